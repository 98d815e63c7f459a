using System.Globalization;

namespace Nowpose.Benchmarks.Links;

/// <summary>Creates names for the namespaces and files of a run. A later run can find leftovers by these names.</summary>
static class RunName
{
    const string Prefix = "nowpose-link-";

    public static string Create(string role) => string.Create(CultureInfo.InvariantCulture, $"{Prefix}{Environment.ProcessId}-{role}");

    /// <summary>Gets the names in a folder that belong to runs that have ended.</summary>
    public static IEnumerable<string> Leftovers(string folder) => Directory.Exists(folder)
        ? Directory.EnumerateFiles(folder, Prefix + "*").Select(Path.GetFileName).Where(name => !IsOwnerAlive(name)).ToList() : [];

    static bool IsOwnerAlive(string name)
    {
        var id = name[Prefix.Length..].Split('-')[0];
        try
        {
            // The process id can now belong to another program.
            return File.ReadAllText($"/proc/{id}/cmdline").Contains(typeof(RunName).Assembly.GetName().Name);
        }
        catch (IOException)
        {
            return false;
        }
    }
}
