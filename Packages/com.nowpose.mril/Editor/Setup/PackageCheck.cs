namespace Nowpose.Editor
{
    sealed class PackageCheck : ProjectCheck
    {
        readonly string _name;
        readonly PackageOrigin _source;
        readonly CheckState _without;

        /// <param name="source">Where it comes from.</param>
        /// <param name="without">How a project stands that has not got it.</param>
        public PackageCheck(
            string title, string why, string name, PackageOrigin source, CheckState without = CheckState.Missing)
            : base(title, why, "Add " + name)
        {
            _name = name;
            _source = source;
            _without = without;
        }

        public override CheckResult Look(IProjectSettings project)
        {
            var version = project.VersionOf(_name);
            if (version != null) return Good(_name + " " + version);
            return new CheckResult(_without, _name + " is not installed");
        }

        public override string Fix(IProjectSettings project)
        {
            project.Add(_source);
            return null;
        }
    }
}
