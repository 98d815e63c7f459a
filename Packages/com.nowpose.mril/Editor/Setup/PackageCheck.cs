namespace Nowpose.Editor
{
    sealed class PackageCheck : ProjectCheck
    {
        readonly string _name;
        readonly PackageOrigin _source;
        readonly string _byHand;
        readonly CheckState _without;

        /// <param name="source">Where it comes from; null where the user has to get it.</param>
        /// <param name="byHand">How the user gets it; null where there is a source.</param>
        /// <param name="without">How a project stands that has not got it.</param>
        public PackageCheck(
            string title, string why, string name, PackageOrigin source = null, string byHand = null,
            CheckState without = CheckState.Missing)
            : base(title, why, source == null ? null : "Add " + name)
        {
            _name = name;
            _source = source;
            _byHand = byHand;
            _without = without;
        }

        public override CheckResult Look(IProjectSettings project)
        {
            var version = project.VersionOf(_name);
            if (version != null) return Good(_name + " " + version);
            return new CheckResult(_without, _name + " is not installed" + (_byHand == null ? "" : "; " + _byHand));
        }

        public override string Fix(IProjectSettings project)
        {
            if (_source == null) return _byHand;
            project.Add(_source);
            return null;
        }
    }
}
