using System.Collections.Generic;
using System.Linq;
using Nowpose.Editor.Messages;

namespace Nowpose.Editor.Setup
{
    /// <summary>Checks the versions of the MRTK3 packages that the sample "HoloLens 2 (MRTK3)" uses. These packages are optional.</summary>
    sealed class Mrtk3Check : ProjectCheck
    {
        public Mrtk3Check()
            : base("MRTK3 (optional)", CheckReasons.Mrtk3, null) { }

        public override CheckResult Look(IProjectSettings project)
        {
            var packages = ProjectNeeds.Mrtk3;
            var missing = packages.Where(package => project.VersionOf(package.Name) == null).Select(package => package.Name).ToList();
            if (missing.Count > 0) return new CheckResult(CheckState.Advice, WhatToDo(missing));
            var wrong = packages.FirstOrDefault(package => package.Serves(project.VersionOf(package.Name)) != true);
            if (wrong == null) return Good("MRTK3 " + project.VersionOf(packages[0].Name));
            var version = project.VersionOf(wrong.Name);
            return new CheckResult(CheckState.Advice, CheckResults.OutsideBounds(wrong.Name, version, wrong.IsTooNew(version), wrong.Bounds));
        }

        public override string Fix(IProjectSettings project) => null;

        static string WhatToDo(List<string> missing) =>
            CheckResults.NotInstalled(string.Join(", ", missing), missing.Count);
    }
}
