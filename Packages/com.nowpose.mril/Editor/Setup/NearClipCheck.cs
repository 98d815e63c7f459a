using System;

namespace Nowpose.Editor.Setup
{
    /// <summary>Checks whether the main camera's near clip plane leaves the depth buffer precise enough for late-stage reprojection.</summary>
    sealed class NearClipCheck : ProjectCheck
    {
        /// <summary>Recommended distance, in metres.</summary>
        const float Wanted = 0.1f;

        /// <summary>Maximum distance, in metres; a plane further away cuts off a gripper that the wearer looks at closely.</summary>
        const float Furthest = 0.3f;

        const float Tolerance = 0.001f;

        /// <summary>Usual distance of a robot, in metres.</summary>
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

        // z² / (n · 2^16), because the depth buffer stores 1/z.
        static double StepMillimetres(float near) => 1000 * Distance * Distance / (near * 65536);
    }
}
