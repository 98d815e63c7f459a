using System.Security.Cryptography;
using System.Text;
using Nowpose.Protocol;

namespace Nowpose.Gateway.Security;

/// <summary>The tokens a gateway accepts, each with its role. Keeps their hashes only. Any thread.</summary>
public sealed class TokenList
{
    public static readonly TokenList None = new([]);

    const string Lines = "\"observer TOKEN\", \"source TOKEN\" or \"operator TOKEN\"";

    static readonly Dictionary<string, Role> Roles =
        new() { ["observer"] = Role.Observer, ["source"] = Role.Source, ["operator"] = Role.Operator };

    // Long enough for an editor that empties the file and writes it anew.
    internal static readonly TimeSpan Settles = TimeSpan.FromMilliseconds(250);

    readonly Func<(byte[] Hash, Role Role)[]> _current;

    IReadOnlyList<(string Where, double Bits)> _weak = [];

    public TokenList(IEnumerable<(string Token, Role Role)> tokens)
    {
        var entries = Hashed(tokens);
        _current = () => entries;
        IsEmpty = entries.Length == 0;
    }

    TokenList(FollowedFile<(byte[] Hash, Role Role)[]> file, string path)
    {
        _current = () => file.Current;
        Path = path;
    }

    /// <summary>Where the file has tokens that are too easily guessed, and how strong they are, bits.</summary>
    internal IReadOnlyList<(string Where, double Bits)> Weak => _weak;

    /// <summary>Of the file; null for a list without.</summary>
    internal string Path { get; }

    /// <summary>Whether it lets in everybody. The list of a file never does: with its last token removed it lets in nobody.</summary>
    public bool IsEmpty { get; }

    /// <summary>Reads lines "observer TOKEN", "source TOKEN" or "operator TOKEN"; empty lines and lines that start with # are skipped.</summary>
    /// <remarks>Follows the file from then on; while it cannot be used, what it said last holds.</remarks>
    /// <param name="log">Is told when the file cannot be used any more; null for nobody.</param>
    /// <exception cref="InputException">A line is something else, or there is none. Names file and line, never the token.</exception>
    public static TokenList Read(string path, Action<string> log = null)
    {
        var tokens = new FollowedFile<(byte[] Hash, Role Role)[]>([path], (out string fault) =>
        {
            fault = null;
            return Hashed(Entries(path));
        }, Settles, log);
        if (tokens.Current.Length == 0)
            throw new InputException($"{path}: holds no token; allowed are lines {Lines}");
        return new TokenList(tokens, path) { _weak = [.. WeakEntries(path)] };
    }

    /// <inheritdoc cref="RoleOf(byte[])"/>
    public Role? RoleOf(string token) => RoleOf(HashOf(token ?? ""));

    /// <summary>The role of a token, or null when it is none of these. Takes as long whichever it is.</summary>
    /// <param name="hash">As <see cref="HashOf"/> makes it.</param>
    public Role? RoleOf(byte[] hash)
    {
        var role = default(Role?);
        foreach (var known in _current())
        {
            // Every token is compared, whole: neither which one nor how much of it fits shows in the time.
            if (CryptographicOperations.FixedTimeEquals(known.Hash, hash))
                role = known.Role;
        }

        return role;
    }

    /// <summary>What is kept of a token, and compared: SHA-256 of its UTF-8.</summary>
    public static byte[] HashOf(string token) => SHA256.HashData(Encoding.UTF8.GetBytes(token));

    /// <summary>Reads the file again if it changed.</summary>
    internal void Follow() => _current();

    static (byte[] Hash, Role Role)[] Hashed(IEnumerable<(string Token, Role Role)> tokens) =>
        [.. tokens.Select(entry => (HashOf(entry.Token), entry.Role))];

    static IEnumerable<(string Token, Role Role)> Entries(string path) => LinesOf(path)
        .Select((line, index) => (Text: line.Trim(), Number: index + 1))
        .Where(line => line.Text.Length > 0 && line.Text[0] != '#')
        .Select(line => Entry(line.Text, $"{path}, line {line.Number}"));

    static IEnumerable<(string Where, double Bits)> WeakEntries(string path) => LinesOf(path)
        .Select((line, index) => (Words: line.Split([' ', '\t'], StringSplitOptions.RemoveEmptyEntries), Where: $"{path}, line {index + 1}"))
        .Where(line => line.Words.Length == 2 && line.Words[0][0] != '#')
        .Select(line => (line.Where, Bits: TokenStrength.BitsOf(line.Words[1])))
        .Where(line => line.Bits < TokenStrength.MinBits);

    static string[] LinesOf(string path)
    {
        try
        {
            return File.ReadAllLines(path);
        }
        catch (Exception e) when (e is IOException or UnauthorizedAccessException)
        {
            throw new InputException($"{path}: cannot be read ({e.Message})", e);
        }
    }

    static (string Token, Role Role) Entry(string line, string where)
    {
        var words = line.Split([' ', '\t'], StringSplitOptions.RemoveEmptyEntries);
        if (words.Length != 2 || !Roles.TryGetValue(words[0], out var role))
            throw new InputException($"{where}: allowed is {Lines}, the token without blanks");
        if (Encoding.UTF8.GetByteCount(words[1]) > ProtocolLimits.TokenBytes)
            throw new InputException($"{where}: the token is longer than {ProtocolLimits.TokenBytes} bytes");
        return (words[1], role);
    }
}
