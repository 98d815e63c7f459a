namespace Nowpose.Gateway.Plants;

/// <summary>A checked plant configuration.</summary>
/// <param name="Path">Path of the file.</param>
/// <param name="Name">Name of the plant, under which its adapter reports.</param>
/// <param name="Summary">A line for the log: the data and their source.</param>
sealed record PlantFile(string Path, string Name, string Summary);
