using System;

namespace Nowpose.Editor
{
    sealed class PackageCheck : ProjectCheck
    {
        readonly string _name;
        readonly PackageOrigin _source;
        readonly CheckState _without;
        readonly Version _least;

        /// <param name="source">Where it comes from.</param>
        /// <param name="without">How a project stands that has not got it.</param>
        /// <param name="least">The oldest version that serves; null for any.</param>
        public PackageCheck(
            string title, string why, string name, PackageOrigin source, CheckState without = CheckState.Missing, string least = null)
            : base(title, why, "Add " + name)
        {
            _name = name;
            _source = source;
            _without = without;
            _least = least == null ? null : Version.Parse(least);
        }

        public override CheckResult Look(IProjectSettings project)
        {
            var version = project.VersionOf(_name);
            if (version != null && (_least == null || PackageVersion.IsAtLeast(version, _least))) return Good(_name + " " + version);
            if (version != null) return new CheckResult(_without, _name + " " + version + " is too old; allowed is " + _least + " or newer");
            return new CheckResult(_without, _name + " is not installed");
        }

        public override string Fix(IProjectSettings project)
        {
            project.Add(_source);
            return null;
        }
    }
}
