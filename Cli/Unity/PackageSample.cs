namespace Nowpose.Cli.Unity;

/// <summary>A sample that is listed in the package.json.</summary>
/// <param name="Name">Name shown in Unity's Package Manager.</param>
/// <param name="Description">Description of one or two sentences.</param>
/// <param name="Folder">Absolute path of the folder with the sample's files.</param>
sealed record PackageSample(string Name, string Description, string Folder);
