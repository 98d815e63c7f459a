using System;

namespace Nowpose.Editor.Setup
{
    /// <summary>Checks whether the package's shaders support the project's render pipeline.</summary>
    sealed class RenderPipelineCheck : ProjectCheck
    {
        public RenderPipelineCheck()
            : base(
                "Render pipeline is the built-in one or URP",
                "The package's shaders support both. The visualisation latency depends on the pipeline: calibrate again "
                + "after a change.", null)
        { }

        public override CheckResult Look(IProjectSettings project)
        {
            const string choose = "choose URP or none under Project Settings, Graphics and Quality";
            var asset = project.RenderPipeline;
            if (asset == null) return Good("built-in render pipeline; the shaders' built-in SubShader is used");
            if (asset.StartsWith("UniversalRenderPipeline", StringComparison.Ordinal))
                return Good("URP (" + asset + "); the shaders' SubShader for URP is used");
            if (asset.StartsWith("HDRenderPipeline", StringComparison.Ordinal))
                return Missing("HDRP (" + asset + "): the package has no shaders for it; " + choose);
            return new CheckResult(CheckState.Unknown, asset + ": the package's shaders do not support it; " + choose);
        }

        public override string Fix(IProjectSettings project) => null;
    }
}
