using System.CommandLine;

namespace Nowpose.Gateway.Options;

/// <summary>Creates options that are either given or not.</summary>
public static class SwitchOption
{
    public static Option<bool> Create(string name, string description) => new(name) { Description = description };
}
