using UnityEditor;

namespace Nowpose.Editor.Setup
{
    /// <summary>A permission that the app has to declare; Windows refuses access without it and reports no error.</summary>
    sealed class CapabilityCheck : ProjectCheck
    {
        readonly PlayerSettings.WSACapability _capability;
        readonly CheckState _without;

        /// <param name="without">State of a project that does not declare the permission.</param>
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
