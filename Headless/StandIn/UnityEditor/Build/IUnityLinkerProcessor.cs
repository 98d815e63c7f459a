using UnityEditor.Build.Reporting;
using UnityEditor.UnityLinker;

namespace UnityEditor.Build;

public interface IUnityLinkerProcessor : IOrderedCallback
{
    string GenerateAdditionalLinkXmlFile(BuildReport report, UnityLinkerBuildPipelineData data);
}

public interface IOrderedCallback
{
    int callbackOrder { get; }
}
