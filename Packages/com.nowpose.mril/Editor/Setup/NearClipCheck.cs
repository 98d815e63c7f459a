using System;
using Nowpose.Editor.Messages;

namespace Nowpose.Editor.Setup
{
    /// <summary>
    /// Checks the distance of the main camera's near clip plane. If it is too small, the depth buffer is too coarse for late-stage reprojection.
    /// </summary>
    sealed class NearClipCheck : ProjectCheck
    {
        /// <summary>Recommended distance of the plane in metres.</summary>
        const float RecommendedMetres = 0.1f;

        /// <summary>Maximum distance of the plane in metres. A larger distance cuts off a gripper that the wearer looks at closely.</summary>
        const float MaxMetres = 0.3f;

        const float ToleranceMetres = 0.001f;

        /// <summary>Usual distance of the robot from the wearer in metres.</summary>
        const double RobotMetres = 1.5;

        public NearClipCheck()
            : base(CheckTitles.NearClip,
                CheckReasons.NearClip, "Set it to 0.1 m")
        { }

        public override CheckResult Look(IProjectSettings project)
        {
            if (!(project.NearClipMetres is float near)) return new CheckResult(CheckState.Unknown, CameraBackgroundCheck.NoCamera);
            var found = FormattableString.Invariant($"{near:0.###} m");
            if (near < RecommendedMetres - ToleranceMetres)
                return Missing(CheckResults.NearClip(found, StepMillimetres(near), RobotMetres));
            return near > MaxMetres + ToleranceMetres
                ? new CheckResult(CheckState.Advice, CheckResults.FarNearClip(found))
                : Good(found);
        }

        public override string Fix(IProjectSettings project)
        {
            if (project.NearClipMetres == null) return CheckFixes.OpenScene;
            project.NearClipMetres = RecommendedMetres;
            return null;
        }

        // A depth buffer of 16 bits stores n/z (n: near clip plane), so one step at the distance z is z² / (n · 2^16).
        static double StepMillimetres(float near) => 1000 * RobotMetres * RobotMetres / (near * 65536);
    }
}
