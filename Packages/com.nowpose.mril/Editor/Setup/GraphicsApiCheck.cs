using Nowpose.Editor.Messages;
using UnityEngine.Rendering;

namespace Nowpose.Editor.Setup
{
    /// <summary>Checks whether Direct3D 11 is the player's only graphics API.</summary>
    sealed class GraphicsApiCheck : ProjectCheck
    {
        public GraphicsApiCheck()
            : base(CheckTitles.GraphicsApi,
                CheckReasons.GraphicsApi, "Use Direct3D 11 only")
        { }

        public override CheckResult Look(IProjectSettings project)
        {
            var apis = project.GraphicsApis;
            var names = string.Join(", ", apis);
            if (apis.Count == 0)
                return new CheckResult(CheckState.Unknown, CheckResults.NoGraphicsApi);
            var isAlone = apis.Count == 1 && apis[0] == GraphicsDeviceType.Direct3D11;
            if (!project.IsGraphicsApiAutomatic) return isAlone ? Good(names) : Missing(names + " in the list");
            return isAlone
                ? new CheckResult(CheckState.Advice, CheckResults.AutomaticApi(names))
                : Missing(CheckResults.AutomaticApi(names));
        }

        public override string Fix(IProjectSettings project)
        {
            project.UseGraphicsApi(GraphicsDeviceType.Direct3D11);
            return null;
        }
    }
}
