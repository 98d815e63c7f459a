namespace Nowpose.Cli.Unity;

/// <summary>A sample that the package's package.json lists.</summary>
/// <param name="Name">Name in Unity's Package Manager.</param>
/// <param name="Description">One or two sentences.</param>
/// <param name="Folder">Absolute path of its files.</param>
sealed record PackageSample(string Name, string Description, string Folder);
