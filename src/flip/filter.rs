//! Separable filters over a plane of numbers; outside of the plane the border is repeated.

/// One number for each pixel, rows from the top.
#[derive(Clone, Debug, PartialEq)]
pub struct Plane {
    /// The width in pixels.
    pub width: usize,
    /// The values, row by row.
    pub values: Vec<f32>,
}

impl Plane {
    /// This plane filtered along x, then along y, by kernels of an odd length.
    pub fn filtered(&self, along_x: &[f32], along_y: &[f32]) -> Self {
        self.along_x(along_x).along_y(along_y)
    }

    fn along_x(&self, kernel: &[f32]) -> Self {
        let radius = kernel.len() / 2;
        let mut values = vec![0.0; self.values.len()];
        let mut padded = vec![0.0; self.width + 2 * radius];
        for (row, out) in self.values.chunks_exact(self.width).zip(values.chunks_exact_mut(self.width)) {
            padded[..radius].fill(row[0]);
            padded[radius..radius + self.width].copy_from_slice(row);
            padded[radius + self.width..].fill(row[self.width - 1]);
            for (offset, &weight) in kernel.iter().enumerate() {
                add_scaled(out, &padded[offset..], weight);
            }
        }
        Self { width: self.width, values }
    }

    fn along_y(&self, kernel: &[f32]) -> Self {
        let radius = kernel.len() / 2;
        let height = self.values.len() / self.width;
        let mut values = vec![0.0; self.values.len()];
        for (y, out) in values.chunks_exact_mut(self.width).enumerate() {
            for (offset, &weight) in kernel.iter().enumerate() {
                let from = (y + offset).saturating_sub(radius).min(height - 1);
                add_scaled(out, &self.values[from * self.width..], weight);
            }
        }
        Self { width: self.width, values }
    }
}

fn add_scaled(out: &mut [f32], from: &[f32], weight: f32) {
    for (out, from) in out.iter_mut().zip(from) {
        *out += weight * from;
    }
}

/// Samples of a function at −radius … radius.
pub fn kernel(radius: u16, at: impl Fn(f32) -> f32) -> Vec<f32> {
    let radius = i32::from(radius);
    #[expect(clippy::cast_precision_loss, reason = "radii are small")]
    (-radius..=radius).map(|offset| at(offset as f32)).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_shift_along_each_axis_repeats_the_border() {
        let plane = Plane { width: 3, values: vec![1.0, 2.0, 3.0, 4.0, 5.0, 6.0] };
        let (still, next) = (&[0.0, 1.0, 0.0][..], &[0.0, 0.0, 1.0][..]);
        assert_eq!(plane.filtered(still, still), plane);
        assert_eq!(plane.filtered(next, still).values, [2.0, 3.0, 3.0, 5.0, 6.0, 6.0]);
        assert_eq!(plane.filtered(still, next).values, [4.0, 5.0, 6.0, 4.0, 5.0, 6.0]);
    }

    #[test]
    fn a_kernel_wider_than_the_picture() {
        let plane = Plane { width: 1, values: vec![3.0] };
        let box_kernel = vec![1.0 / 21.0; 21];
        assert!((plane.filtered(&box_kernel, &box_kernel).values[0] - 3.0).abs() < 1e-5);
    }
}
