using UnityEditor;

namespace Nowpose.Editor.Setup
{
    /// <summary>Checks whether the app declares a capability. Without it, Windows refuses access and does not report an error.</summary>
    sealed class CapabilityCheck : ProjectCheck
    {
        readonly PlayerSettings.WSACapability _capability;
        readonly CheckState _without;

        /// <param name="why">Purpose of the capability.</param>
        /// <param name="without">State of a project that does not declare the capability.</param>
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
