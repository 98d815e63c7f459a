using System;
using System.Linq;
using Nowpose.Editor.Messages;

namespace Nowpose.Editor.Setup
{
    /// <summary>Checks whether packages are installed in supported versions.</summary>
    static class PackageChecks
    {
        /// <summary>Checks whether OpenXR is installed in a version that supports the player.</summary>
        public static ProjectCheck OpenXr { get; } =
            Of("OpenXR", CheckReasons.OpenXr, ProjectNeeds.OpenXr.Name, ProjectNeeds.OpenXrFor, CheckState.Missing);

        /// <summary>Checks the versions of the MRTK3 packages that the sample "HoloLens 2 (MRTK3)" uses. These packages are optional.</summary>
        public static ProjectCheck Mrtk3 { get; } = new ProjectCheck("MRTK3 (optional)", CheckReasons.Mrtk3, project =>
        {
            var packages = ProjectNeeds.Mrtk3;
            var missing = packages.Where(package => project.VersionOf(package.Name) == null).Select(package => package.Name).ToList();
            if (missing.Count > 0) return CheckResult.Advice(CheckResults.NotInstalled(string.Join(", ", missing), missing.Count));
            var wrong = packages.FirstOrDefault(package => package.Serves(project.VersionOf(package.Name)) != true);
            return wrong == null
                ? CheckResult.Good("MRTK3 " + project.VersionOf(packages[0].Name))
                : CheckResult.Advice(OutsideBounds(wrong, project.VersionOf(wrong.Name)));
        });

        /// <summary>Checks whether the major versions of MRTK and XR Interaction Toolkit, if installed, are supported by the package.</summary>
        public static ProjectCheck MrtkGeneration { get; } = new ProjectCheck(CheckTitles.MrtkGeneration, CheckReasons.MrtkGeneration, project =>
        {
            var packages = ProjectNeeds.Mrtk3.Append(ProjectNeeds.XrInteraction).Where(package => project.VersionOf(package.Name) != null).ToList();
            var tooNew = packages.Where(package => package.IsTooNew(project.VersionOf(package.Name))).ToList();
            if (packages.Count == 0) return CheckResult.Good("neither is installed");
            if (tooNew.Count == 0) return CheckResult.Good(packages[0].Name + " " + project.VersionOf(packages[0].Name));
            return CheckResult.Missing(CheckResults.NotSupported(
                string.Join(", ", tooNew.Select(package => package.Name + " " + project.VersionOf(package.Name))), tooNew.Count,
                string.Join(", ", tooNew.Select(package => package.Name + " " + PackageVersion.Read(package.Reference)))));
        });

        /// <summary>Checks whether a package is installed in a supported version.</summary>
        /// <param name="without">State of a project without the package or with an unsupported version.</param>
        public static ProjectCheck Of(string title, string why, PackageOrigin package, CheckState without = CheckState.Missing) =>
            Of(title, why, package.Name, project => package, without);

        static ProjectCheck Of(
            string title, string why, string name, Func<IProjectSettings, PackageOrigin> needed, CheckState without) => new ProjectCheck(
            title, why,
            project =>
            {
                var package = needed(project);
                var version = project.VersionOf(package.Name);
                if (version == null) return new CheckResult(without, CheckResults.NotInstalled(package.Name));
                return package.Serves(version) == true
                    ? CheckResult.Good(package.Name + " " + version) : new CheckResult(without, OutsideBounds(package, version));
            },
            CheckTitles.AddPackage(name), ProjectCheck.Always(project => project.Add(needed(project))));

        static string OutsideBounds(PackageOrigin package, string version) =>
            CheckResults.OutsideBounds(package.Name, version, package.IsTooNew(version), package.Bounds);
    }
}
