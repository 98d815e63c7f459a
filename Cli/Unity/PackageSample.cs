namespace Nowpose.Cli.Unity;

/// <summary>A sample as the package's package.json lists it.</summary>
/// <param name="Name">As Unity's Package Manager shows it.</param>
/// <param name="Description">One or two sentences.</param>
/// <param name="Folder">Absolute path of its files.</param>
sealed record PackageSample(string Name, string Description, string Folder);
