using System;
using Nowpose.Editor.Messages;

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
            : base(CheckTitles.NearClip,
                CheckReasons.NearClip, "Set it to 0.1 m")
        { }

        public override CheckResult Look(IProjectSettings project)
        {
            if (!(project.NearClipMetres is float near)) return new CheckResult(CheckState.Unknown, CameraBackgroundCheck.NoCamera);
            var found = FormattableString.Invariant($"{near:0.###} m");
            if (near < Wanted - Tolerance)
                return Missing(CheckResults.NearClip(found, StepMillimetres(near), Distance));
            return near > Furthest + Tolerance
                ? new CheckResult(CheckState.Advice, CheckResults.FarNearClip(found))
                : Good(found);
        }

        public override string Fix(IProjectSettings project)
        {
            if (project.NearClipMetres == null) return CheckFixes.OpenScene;
            project.NearClipMetres = Wanted;
            return null;
        }

        // z² / (n · 2^16), because the depth buffer stores 1/z.
        static double StepMillimetres(float near) => 1000 * Distance * Distance / (near * 65536);
    }
}
