using System;
using Nowpose.Editor.Messages;
using UnityEngine.Rendering;

namespace Nowpose.Editor.Setup
{
    /// <summary>Checks of the graphics settings and of the main camera.</summary>
    static class RenderingChecks
    {
        /// <summary>Recommended distance of the near clip plane in metres.</summary>
        const float NearMetres = 0.1f;

        /// <summary>Maximum distance of the near clip plane in metres. A larger distance cuts off a gripper that the wearer looks at closely.</summary>
        const float MaxNearMetres = 0.3f;

        const float ToleranceMetres = 0.001f;

        /// <summary>Usual distance of the robot from the wearer in metres.</summary>
        const double RobotMetres = 1.5;

        /// <summary>Checks whether Direct3D 11 is the player's only graphics API.</summary>
        public static ProjectCheck GraphicsApi { get; } = new ProjectCheck(
            CheckTitles.GraphicsApi, CheckReasons.GraphicsApi, LookAtApi, "Use Direct3D 11 only",
            ProjectCheck.Always(project => project.UseGraphicsApi(GraphicsDeviceType.Direct3D11)));

        /// <summary>Checks whether Graphics Jobs are off. If they are on, Unity distributes its rendering commands to worker threads.</summary>
        public static ProjectCheck GraphicsJobs { get; } = new ProjectCheck(
            CheckTitles.GraphicsJobs, CheckReasons.GraphicsJobs,
            project => project.UsesGraphicsJobs switch
            {
                false => CheckResult.Good("off"),
                true => CheckResult.Advice("on"),
                null => CheckResult.Unknown(CheckResults.OtherBuildTarget),
            },
            CheckTitles.TurnGraphicsJobsOff, project =>
            {
                if (project.UsesGraphicsJobs == null) return CheckFixes.BuildTarget;
                project.TurnGraphicsJobsOff();
                return null;
            });

        /// <summary>Checks whether the package's shaders support the project's render pipeline.</summary>
        public static ProjectCheck Pipeline { get; } = new ProjectCheck(CheckTitles.RenderPipeline, CheckReasons.RenderPipeline, LookAtPipeline);

        /// <summary>
        /// Checks whether the main camera of the open scenes clears to black with alpha 0. A see-through display shows this colour as transparent,
        /// and video passthrough is visible through it.
        /// </summary>
        public static ProjectCheck CameraBackground { get; } = new ProjectCheck(
            CheckTitles.CameraBackground, CheckReasons.CameraBackground,
            project => project.ClearsToTransparentBlack switch
            {
                true => CheckResult.Good("solid colour (0, 0, 0, 0)"),
                false => CheckResult.Missing(CheckResults.CameraBackground),
                null => CheckResult.Unknown(CheckResults.NoCamera),
            },
            CheckTitles.ClearToBlack, project =>
            {
                if (project.ClearsToTransparentBlack == null) return CheckFixes.OpenScene;
                project.ClearToTransparentBlack();
                return null;
            });

        /// <summary>
        /// Checks the distance of the main camera's near clip plane. If it is too small, the depth buffer is too coarse for late-stage reprojection.
        /// </summary>
        public static ProjectCheck NearClip { get; } = new ProjectCheck(
            CheckTitles.NearClip, CheckReasons.NearClip, LookAtNearClip, "Set it to 0.1 m", project =>
            {
                if (project.NearClipMetres == null) return CheckFixes.OpenScene;
                project.NearClipMetres = NearMetres;
                return null;
            });

        static CheckResult LookAtApi(IProjectSettings project)
        {
            var apis = project.GraphicsApis;
            var names = string.Join(", ", apis);
            if (apis.Count == 0) return CheckResult.Unknown(CheckResults.NoGraphicsApi);
            var isAlone = apis.Count == 1 && apis[0] == GraphicsDeviceType.Direct3D11;
            if (!project.IsGraphicsApiAutomatic) return isAlone ? CheckResult.Good(names) : CheckResult.Missing(names + " in the list");
            return new CheckResult(isAlone ? CheckState.Advice : CheckState.Missing, CheckResults.AutomaticApi(names));
        }

        static CheckResult LookAtPipeline(IProjectSettings project)
        {
            var asset = project.RenderPipeline;
            if (asset == null) return CheckResult.Good(CheckResults.BuiltIn);
            if (asset.StartsWith("UniversalRenderPipeline", StringComparison.Ordinal)) return CheckResult.Good(CheckResults.Urp(asset));
            if (asset.StartsWith("HDRenderPipeline", StringComparison.Ordinal)) return CheckResult.Missing(CheckResults.Hdrp(asset));
            return CheckResult.Unknown(CheckResults.OtherPipeline(asset));
        }

        static CheckResult LookAtNearClip(IProjectSettings project)
        {
            if (!(project.NearClipMetres is float near)) return CheckResult.Unknown(CheckResults.NoCamera);
            var found = FormattableString.Invariant($"{near:0.###} m");
            var close = project.Platform == HeadsetPlatform.HoloLens2 ? CheckState.Missing : CheckState.Advice;
            if (near < NearMetres - ToleranceMetres) return new CheckResult(close, CheckResults.NearClip(found, StepMillimetres(near), RobotMetres));
            return near > MaxNearMetres + ToleranceMetres ? CheckResult.Advice(CheckResults.FarNearClip(found)) : CheckResult.Good(found);
        }

        // A depth buffer of 16 bits stores n/z (n: near clip plane), so one step at the distance z is z² / (n · 2^16).
        static double StepMillimetres(float near) => 1000 * RobotMetres * RobotMetres / (near * 65536);
    }
}
