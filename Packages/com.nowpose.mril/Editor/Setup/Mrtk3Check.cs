using System.Linq;

namespace Nowpose.Editor
{
    /// <summary>The packages of MRTK3 that the sample for it uses. Nothing else needs them.</summary>
    sealed class Mrtk3Check : ProjectCheck
    {
        static readonly string[] Packages =
        {
            "org.mixedrealitytoolkit.core", "org.mixedrealitytoolkit.uxcore", "org.mixedrealitytoolkit.standardassets",
            "org.mixedrealitytoolkit.spatialmanipulation", "org.mixedrealitytoolkit.uxcomponents", "org.mixedrealitytoolkit.input",
            "org.mixedrealitytoolkit.windowsspeech",
        };

        public Mrtk3Check()
            : base("MRTK3 (optional)", "Hand menu, voice and grabbing of the sample HoloLens 2 (MRTK3); the package works without.", null) { }

        public override CheckResult Look(IProjectSettings project)
        {
            var missing = Packages.Where(name => project.VersionOf(name) == null).ToList();
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
