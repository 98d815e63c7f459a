using Nowpose.Editor.Messages;

namespace Nowpose.Editor.Setup
{
    /// <summary>Checks whether a package is installed in a supported version.</summary>
    sealed class PackageCheck : ProjectCheck
    {
        readonly PackageOrigin _package;
        readonly CheckState _without;

        /// <param name="without">State of a project without the package or with an unsupported version.</param>
        public PackageCheck(string title, string why, PackageOrigin package, CheckState without = CheckState.Missing)
            : base(title, why, "Add " + package.Name)
        {
            _package = package;
            _without = without;
        }

        public override CheckResult Look(IProjectSettings project)
        {
            var version = project.VersionOf(_package.Name);
            if (version == null) return new CheckResult(_without, CheckResults.NotInstalled(_package.Name));
            if (_package.Serves(version) == true) return Good(_package.Name + " " + version);
            return new CheckResult(_without, CheckResults.OutsideBounds(_package.Name, version, _package.IsTooNew(version), _package.Bounds));
        }

        public override string Fix(IProjectSettings project)
        {
            project.Add(_package);
            return null;
        }
    }
}
