using System.Text.Json;

namespace Nowpose.Cli.Demo;

/// <summary>Creates the content of result.json: the fields of <see cref="DemoResult"/> in snake case, as specified in cli.md.</summary>
static class DemoResultJson
{
    static readonly JsonSerializerOptions Options = new()
    {
        PropertyNamingPolicy = JsonNamingPolicy.SnakeCaseLower,
        WriteIndented = true,
    };

    /// <exception cref="ArgumentException">A number is not finite. JSON has no NaN, and a valid run has only finite numbers.</exception>
    public static string Of(DemoResult result) => JsonSerializer.Serialize(result, Options);
}
