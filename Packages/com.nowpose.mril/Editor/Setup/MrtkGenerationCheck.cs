using System.Linq;
using Nowpose.Editor.Messages;

namespace Nowpose.Editor.Setup
{
    /// <summary>Checks whether the major versions of MRTK and XR Interaction Toolkit, if installed, are supported by the package.</summary>
    sealed class MrtkGenerationCheck : ProjectCheck
    {
        public MrtkGenerationCheck()
            : base(CheckTitles.MrtkGeneration,
                CheckReasons.MrtkGeneration, null)
        { }

        public override CheckResult Look(IProjectSettings project)
        {
            var packages = ProjectNeeds.Mrtk3.Append(ProjectNeeds.XrInteraction).Where(package => project.VersionOf(package.Name) != null).ToList();
            var tooNew = packages.Where(package => package.IsTooNew(project.VersionOf(package.Name))).ToList();
            if (packages.Count == 0) return Good("neither is installed");
            if (tooNew.Count == 0) return Good(packages[0].Name + " " + project.VersionOf(packages[0].Name));
            return Missing(CheckResults.NotSupported(
                string.Join(", ", tooNew.Select(package => package.Name + " " + project.VersionOf(package.Name))), tooNew.Count,
                string.Join(", ", tooNew.Select(package => package.Name + " " + PackageVersion.Read(package.Reference)))));
        }

        public override string Fix(IProjectSettings project) => null;
    }
}
