namespace Nowpose.Gateway.Plants;

/// <summary>A plant's configuration that was checked.</summary>
/// <param name="Path">Of the file.</param>
/// <param name="Name">Of the plant: its adapter reports under it.</param>
/// <param name="Summary">A line for the log: what is read from where.</param>
sealed record PlantFile(string Path, string Name, string Summary);
