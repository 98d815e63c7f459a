using System.Reflection;

namespace Nowpose.Cli;

/// <summary>The version of this program, as in results.</summary>
static class ProgramVersion
{
    /// <summary>The version and the commit, for example 0.2.0+1a2b3c4; without the commit if the source was not a clone.</summary>
    public static string Text { get; } =
        typeof(ProgramVersion).Assembly.GetCustomAttribute<AssemblyInformationalVersionAttribute>()!.InformationalVersion;
}
