using UnityEngine.Rendering;

namespace Nowpose.Editor.Setup
{
    /// <summary>Checks whether Direct3D 11 is the player's only graphics API.</summary>
    sealed class GraphicsApiCheck : ProjectCheck
    {
        public GraphicsApiCheck()
            : base(
                "Graphics API is Direct3D 11 only",
                "The visualisation latency depends on it, so a calibration is valid for one API only. Unity 6 selects Direct3D 12 automatically, "
                + "which is slower on a HoloLens 2 according to Unity's measurements.", "Use Direct3D 11 only")
        { }

        public override CheckResult Look(IProjectSettings project)
        {
            var apis = project.GraphicsApis;
            var names = string.Join(", ", apis);
            if (apis.Count == 0)
                return new CheckResult(CheckState.Unknown, "Unity names no graphics API for this player; its module is not installed");
            var isAlone = apis.Count == 1 && apis[0] == GraphicsDeviceType.Direct3D11;
            if (!project.IsGraphicsApiAutomatic) return isAlone ? Good(names) : Missing(names + " in the list");
            return isAlone
                ? new CheckResult(CheckState.Advice, "automatic, which is " + names + " in this version of Unity")
                : Missing("automatic, which is " + names + " in this version of Unity");
        }

        public override string Fix(IProjectSettings project)
        {
            project.UseGraphicsApi(GraphicsDeviceType.Direct3D11);
            return null;
        }
    }
}
