using System;
using System.Linq;

namespace Nowpose.Editor
{
    /// <summary>The packages of MRTK3 that the sample for it uses. Nothing else needs them.</summary>
    sealed class Mrtk3Check : ProjectCheck
    {
        const string UxComponents = "org.mixedrealitytoolkit.uxcomponents";

        /// <summary>The first that has the button with a checkbox, of which the menu is made.</summary>
        static readonly Version LeastUxComponents = new Version(3, 3, 0);

        static readonly string[] Packages =
        {
            "org.mixedrealitytoolkit.core", "org.mixedrealitytoolkit.uxcore", "org.mixedrealitytoolkit.standardassets",
            "org.mixedrealitytoolkit.spatialmanipulation", UxComponents, "org.mixedrealitytoolkit.input",
            "org.mixedrealitytoolkit.windowsspeech",
        };

        public Mrtk3Check()
            : base("MRTK3 (optional)", "Hand menu, voice and grabbing of the sample HoloLens 2 (MRTK3); the package works without.", null) { }

        public override CheckResult Look(IProjectSettings project)
        {
            var missing = Packages.Where(name => project.VersionOf(name) == null).ToList();
            var components = project.VersionOf(UxComponents);
            if (missing.Count == 0 && !PackageVersion.IsAtLeast(components, LeastUxComponents))
                return new CheckResult(CheckState.Advice, UxComponents + " " + components + " is too old; allowed is " + LeastUxComponents + " or newer");
            return missing.Count == 0
                ? Good("MRTK3 " + project.VersionOf(Packages[0]))
                : new CheckResult(
                    CheckState.Advice,
                    string.Join(", ", missing) + (missing.Count == 1 ? " is" : " are")
                    + " not installed; get the tarballs from the releases of github.com/MixedRealityToolkit/MixedRealityToolkit-Unity");
        }

        public override string Fix(IProjectSettings project) => null;
    }
}
