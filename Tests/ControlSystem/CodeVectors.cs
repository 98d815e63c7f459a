using System.Globalization;

namespace Nowpose.Headless.Tests.ControlSystem;

/// <summary>
/// Reads led-matrix/timestamp-codes.csv. It contains codes that another program has computed. The package, the gateway's page and the PLC's
/// program must produce the same codes.
/// </summary>
static class CodeVectors
{
    public sealed record Row(int ValueMs, string Kind, byte[] Rows);

    public static IReadOnlyList<Row> Read() =>
    [
        .. File.ReadLines(PathOf("timestamp-codes.csv")).Skip(1).Select(line => line.Split(','))
            .Select(cells => new Row(int.Parse(cells[0], CultureInfo.InvariantCulture), cells[1], Convert.FromHexString(cells[2]))),
    ];

    public static string PathOf(string file) => Path.Combine(RepositoryFiles.Root, RepositoryFiles.Package, "Documentation~", "led-matrix", file);
}
