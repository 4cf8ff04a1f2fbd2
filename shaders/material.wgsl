// How surfaces of shapes and meshes give back light: a matt part, and a part that mirrors the sun (GGX) and what is around. What is mirrored
// is missing in the matt part, so that no surface gives back more than it gets.

// The light, exposure included, as constants: a software driver reads a uniform far more slowly than it computes with it.
override TOWARDS_SUN_X: f32 = 0.0;
override TOWARDS_SUN_Y: f32 = 1.0;
override TOWARDS_SUN_Z: f32 = 0.0;
override SUN_RED: f32 = 0.0;
override SUN_GREEN: f32 = 0.0;
override SUN_BLUE: f32 = 0.0;
override SKY_RED: f32 = 0.0;
override SKY_GREEN: f32 = 0.0;
override SKY_BLUE: f32 = 0.0;
override GROUND_RED: f32 = 0.0;
override GROUND_GREEN: f32 = 0.0;
override GROUND_BLUE: f32 = 0.0;
override HORIZON_RED: f32 = 0.0;
override HORIZON_GREEN: f32 = 0.0;
override HORIZON_BLUE: f32 = 0.0;
override ZENITH_RED: f32 = 0.0;
override ZENITH_GREEN: f32 = 0.0;
override ZENITH_BLUE: f32 = 0.0;

fn towards_sun() -> vec3f {
    return vec3f(TOWARDS_SUN_X, TOWARDS_SUN_Y, TOWARDS_SUN_Z);
}

// What a dielectric mirrors of light that falls straight on it.
const FACING: f32 = 0.04;

// Near the ground less light comes from the side, and least from below. In a sub-frame the sky has shadows, and only the light from below
// is lessened.
fn ambient_arriving(height_in_world: f32, upwards: f32) -> f32 {
    let above = max(height_in_world - globals.zenith.w, 0.0);
    if IS_SUB_FRAME {
        return 1.0 - 0.56 * exp2(-4.0 * above);
    }
    return 1.0 - (0.34 - 0.22 * upwards) * exp2(-4.0 * above);
}

// The light of a surface, exposure included: what it gives back of the sky and the ground, and of the whole sun.
struct GivenBack {
    ambient: vec3f,
    sun: vec3f,
}

// `finish`: what `Finish` in `src/render/instances.rs` says. `sky_arriving`: as `light_arriving` says. `ambient`: as `ambient_arriving` says.
fn given_back(albedo: vec3f, finish: vec4f, normal: vec3f, to_eye: vec3f, sky_arriving: f32, ambient: f32) -> GivenBack {
    let to_sun = towards_sun();
    let of_sun = vec3f(SUN_RED, SUN_GREEN, SUN_BLUE);
    let of_sky = vec3f(SKY_RED, SKY_GREEN, SKY_BLUE);
    let of_ground = vec3f(GROUND_RED, GROUND_GREEN, GROUND_BLUE);
    let horizon = vec3f(HORIZON_RED, HORIZON_GREEN, HORIZON_BLUE);
    let zenith = vec3f(ZENITH_RED, ZENITH_GREEN, ZENITH_BLUE);
    let facing_eye = max(dot(normal, to_eye), 0.0);
    let facing_sun = max(dot(normal, to_sun), 0.0);
    let alpha = finish.x;
    let metalness = finish.w;

    // The part that is mirrored, which Schlick's term raises at grazing angles.
    let grazing = finish.z * pow2(pow2(1.0 - facing_eye));
    let facing = mix(vec3f(FACING), albedo, metalness);
    let of_lamps = facing + (1.0 - facing) * grazing;
    // A rough metal mirrors light several times between its facets, until it comes back from all sides.
    let several = metalness * alpha * (0.45 + 0.15 * alpha);
    // The rougher a dielectric is, the less it mirrors of what is around.
    let blurred = FACING * (1.0 - finish.z);
    let of_surroundings = of_lamps - albedo * several - blurred;
    let matt = albedo * ((1.0 - metalness + several) * ((1.0 - FACING) * (1.0 - grazing) + blurred));

    // What is around: the ground below, the sky above, the horizon between them as blurred as the surface is rough.
    let up = 2.0 * facing_eye * normal.y - to_eye.y;
    let is_sky = saturate(0.5 + finish.y * up);
    var around = of_ground + (horizon - of_ground) * is_sky + (zenith - horizon) * saturate(up);
    var fill = of_ground + (of_sky - of_ground) * sky_arriving;
    var dimmed = ambient;
    if IS_SUB_FRAME {
        let sky = 0.5 + 0.5 * normal.y;
        around += of_ground * ((1.0 - is_sky) * (ambient - 1.0)) + horizon * (is_sky * (sky_arriving - sky));
        fill = of_ground * (ambient * (1.0 - sky)) + of_sky * sky_arriving;
        dimmed = 1.0;
    }

    // The sun's highlight: GGX, and the fitted visibility of Hammon (2017); a quotient for both. The bound keeps grazing views of surfaces
    // that only a part of a wide sun reaches from glaring.
    let squared = alpha * alpha;
    let along = 2.0 + 2.0 * dot(to_sun, to_eye);
    let narrow = pow2(facing_sun + facing_eye) * (squared - 1.0) + along;
    let visible = max(mix(2.0 * facing_sun * facing_eye, facing_sun + facing_eye, alpha), 0.02);
    let lobe = 0.5 * squared * pow2(along) / max(pow2(narrow) * visible, 1e-6);

    return GivenBack(dimmed * (of_surroundings * around + matt * fill), of_sun * (of_lamps * lobe + matt));
}

fn pow2(x: f32) -> f32 {
    return x * x;
}
