namespace UnityEditor.UnityLinker;

public sealed class UnityLinkerBuildPipelineData
{
    public readonly BuildTarget target;

    public UnityLinkerBuildPipelineData(BuildTarget target, string inputDirectory) => this.target = target;
}
