using UnityEditor;

namespace Nowpose.Editor.Setup
{
    /// <summary>A permission that the app has to declare; Windows refuses what is not declared, without a word.</summary>
    sealed class CapabilityCheck : ProjectCheck
    {
        readonly PlayerSettings.WSACapability _capability;
        readonly CheckState _without;

        /// <param name="without">How a project stands that does not declare it.</param>
        public CapabilityCheck(PlayerSettings.WSACapability capability, string why, CheckState without = CheckState.Missing)
            : base("Capability " + capability, why, "Declare " + capability)
        {
            _capability = capability;
            _without = without;
        }

        public override CheckResult Look(IProjectSettings project) =>
            project.IsAllowed(_capability) ? Good("declared") : new CheckResult(_without, "not declared");

        public override string Fix(IProjectSettings project)
        {
            project.Allow(_capability);
            return null;
        }
    }
}
