namespace Nowpose.Editor.Setup
{
    /// <summary>
    /// Checks whether the main camera of the open scenes clears to black with alpha 0. A see-through display shows this colour as transparent.
    /// </summary>
    sealed class CameraBackgroundCheck : ProjectCheck
    {
        public const string NoCamera = "the open scenes have no enabled camera with the tag MainCamera; open the scene of the headset";

        public CameraBackgroundCheck()
            : base(
                "Main camera clears to black with alpha 0",
                "Black is transparent on a see-through display. A skybox or a colour covers the real robot, and pictures that the headset "
                + "takes need the alpha.", "Clear to black with alpha 0")
        { }

        public override CheckResult Look(IProjectSettings project)
        {
            switch (project.ClearsToTransparentBlack)
            {
                case true: return Good("solid colour (0, 0, 0, 0)");
                case false: return Missing("the camera clears to a skybox or to another colour");
                default: return new CheckResult(CheckState.Unknown, NoCamera);
            }
        }

        public override string Fix(IProjectSettings project)
        {
            if (project.ClearsToTransparentBlack == null) return "Open a scene with a main camera first.";
            project.ClearToTransparentBlack();
            return null;
        }
    }
}
