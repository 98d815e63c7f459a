using System;

namespace Nowpose.Editor.Setup
{
    /// <summary>
    /// Checks the distance of the main camera's near clip plane. If it is too small, the depth buffer is too coarse for late-stage reprojection.
    /// </summary>
    sealed class NearClipCheck : ProjectCheck
    {
        /// <summary>Recommended distance of the plane in metres.</summary>
        const float Wanted = 0.1f;

        /// <summary>Maximum distance of the plane in metres. A larger distance cuts off a gripper that the wearer looks at closely.</summary>
        const float Furthest = 0.3f;

        const float Tolerance = 0.001f;

        /// <summary>Usual distance of the robot from the wearer in metres.</summary>
        const double Distance = 1.5;

        public NearClipCheck()
            : base(
                "Main camera's near clip plane is at 0.1 m",
                "The headset stabilises the picture with a 16-bit depth, whose steps are larger if the plane is closer: at 1.5 m they are "
                + "0.34 mm with 0.1 m, and 1.7 mm with the 0.02 m of MRTK3's rig.", "Set it to 0.1 m")
        { }

        public override CheckResult Look(IProjectSettings project)
        {
            if (!(project.NearClipMetres is float near)) return new CheckResult(CheckState.Unknown, CameraBackgroundCheck.NoCamera);
            var found = FormattableString.Invariant($"{near:0.###} m");
            if (near < Wanted - Tolerance)
                return Missing(FormattableString.Invariant($"{found}; one step of the depth is {StepMillimetres(near):0.##} mm at {Distance} m"));
            return near > Furthest + Tolerance
                ? new CheckResult(CheckState.Advice, found + "; objects closer to the eyes are not drawn")
                : Good(found);
        }

        public override string Fix(IProjectSettings project)
        {
            if (project.NearClipMetres == null) return "Open a scene with a main camera first.";
            project.NearClipMetres = Wanted;
            return null;
        }

        // A depth buffer of 16 bits stores n/z (n: near clip plane), so one step at the distance z is z² / (n · 2^16).
        static double StepMillimetres(float near) => 1000 * Distance * Distance / (near * 65536);
    }
}
