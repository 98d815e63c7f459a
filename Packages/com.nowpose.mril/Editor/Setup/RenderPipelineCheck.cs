using System;
using Nowpose.Editor.Messages;

namespace Nowpose.Editor.Setup
{
    /// <summary>Checks whether the package's shaders support the project's render pipeline.</summary>
    sealed class RenderPipelineCheck : ProjectCheck
    {
        public RenderPipelineCheck()
            : base(CheckTitles.RenderPipeline,
                CheckReasons.RenderPipeline, null)
        { }

        public override CheckResult Look(IProjectSettings project)
        {
            var asset = project.RenderPipeline;
            if (asset == null) return Good(CheckResults.BuiltIn);
            if (asset.StartsWith("UniversalRenderPipeline", StringComparison.Ordinal))
                return Good(CheckResults.Urp(asset));
            if (asset.StartsWith("HDRenderPipeline", StringComparison.Ordinal))
                return Missing(CheckResults.Hdrp(asset));
            return new CheckResult(CheckState.Unknown, CheckResults.OtherPipeline(asset));
        }

        public override string Fix(IProjectSettings project) => null;
    }
}
