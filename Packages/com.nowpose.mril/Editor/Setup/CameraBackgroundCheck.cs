using Nowpose.Editor.Messages;

namespace Nowpose.Editor.Setup
{
    /// <summary>
    /// Checks whether the main camera of the open scenes clears to black with alpha 0. A see-through display shows this colour as transparent.
    /// </summary>
    sealed class CameraBackgroundCheck : ProjectCheck
    {
        public const string NoCamera = CheckResults.NoCamera;

        public CameraBackgroundCheck()
            : base(CheckTitles.CameraBackground,
                CheckReasons.CameraBackground, CheckTitles.ClearToBlack)
        { }

        public override CheckResult Look(IProjectSettings project)
        {
            switch (project.ClearsToTransparentBlack)
            {
                case true: return Good("solid colour (0, 0, 0, 0)");
                case false: return Missing(CheckResults.CameraBackground);
                default: return new CheckResult(CheckState.Unknown, NoCamera);
            }
        }

        public override string Fix(IProjectSettings project)
        {
            if (project.ClearsToTransparentBlack == null) return CheckFixes.OpenScene;
            project.ClearToTransparentBlack();
            return null;
        }
    }
}
