using System.Linq;

namespace Nowpose.Editor.Setup
{
    /// <summary>Checks whether the major versions of MRTK and XR Interaction Toolkit, if installed, are supported by the package.</summary>
    sealed class MrtkGenerationCheck : ProjectCheck
    {
        public MrtkGenerationCheck()
            : base(
                "MRTK is 3 and XR Interaction Toolkit is 2, where they are installed",
                "MRTK 4 and XR Interaction Toolkit 3 moved the types that the hand menu, voice and grabbing use. With them these components are not "
                + "compiled, and the sample HoloLens 2 (MRTK3) shows missing scripts.", null)
        { }

        public override CheckResult Look(IProjectSettings project)
        {
            var packages = ProjectNeeds.Mrtk3.Append(ProjectNeeds.XrInteraction).Where(package => project.VersionOf(package.Name) != null).ToList();
            var tooNew = packages.Where(package => package.IsTooNew(project.VersionOf(package.Name))).ToList();
            if (packages.Count == 0) return Good("neither is installed");
            if (tooNew.Count == 0) return Good(packages[0].Name + " " + project.VersionOf(packages[0].Name));
            return Missing(
                string.Join(", ", tooNew.Select(package => package.Name + " " + project.VersionOf(package.Name)))
                + (tooNew.Count == 1 ? " is" : " are")
                + " not supported; close Unity and run `nowpose unity PATH --mrtk3 --on-conflict replace`, or write "
                + string.Join(", ", tooNew.Select(package => package.Name + " " + PackageVersion.Read(package.Reference)))
                + " into Packages/manifest.json");
        }

        public override string Fix(IProjectSettings project) => null;
    }
}
