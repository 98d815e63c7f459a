using UnityEditor;

namespace Nowpose.Editor
{
    /// <summary>A permission that the app has to declare; Windows refuses what is not declared, without a word.</summary>
    sealed class CapabilityCheck : ProjectCheck
    {
        readonly PlayerSettings.WSACapability _capability;

        public CapabilityCheck(PlayerSettings.WSACapability capability, string why)
            : base("Capability " + capability, why, "Declare " + capability) => _capability = capability;

        public override CheckResult Look(IProjectSettings project) => project.IsAllowed(_capability) ? Good("declared") : Missing("not declared");

        public override string Fix(IProjectSettings project)
        {
            project.Allow(_capability);
            return null;
        }
    }
}
