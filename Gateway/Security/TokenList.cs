using System.Security.Cryptography;
using System.Text;
using Nowpose.Gateway.Messages;
using Nowpose.Protocol;

namespace Nowpose.Gateway.Security;

/// <summary>The tokens that a gateway accepts, with their roles. Stores only hashes of the tokens. Thread-safe.</summary>
public sealed class TokenList
{
    public static readonly TokenList None = new([]);

    static readonly Dictionary<string, Role> Roles =
        new() { ["observer"] = Role.Observer, ["source"] = Role.Source, ["operator"] = Role.Operator };

    // Minimum age of a change before the file is read again. An editor that truncates the file first has then written the new content.
    internal static readonly TimeSpan Settles = TimeSpan.FromMilliseconds(250);

    readonly Func<(byte[] Hash, Role Role)[]> _current;
    readonly Func<string> _fault = () => null;

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
        _fault = () => file.Fault;
        Path = path;
    }

    /// <summary>File and line of each token that is too easy to guess, with its strength in bits.</summary>
    internal IReadOnlyList<(string Where, double Bits)> Weak => _weak;

    /// <summary>Path of the file; null for a list that was not read from a file.</summary>
    internal string Path { get; }

    /// <inheritdoc cref="FollowedFile{T}.Fault"/>
    internal string Fault => _fault();

    /// <summary>
    /// Whether the gateway requires no token. False for any file: if its last token is removed later, no client is accepted.
    /// </summary>
    public bool IsEmpty { get; }

    /// <summary>
    /// Reads a file of lines "observer TOKEN", "source TOKEN" or "operator TOKEN". Skips empty lines and lines that start with #.
    /// </summary>
    /// <remarks>The list follows changes of the file. While the file is invalid, its last valid content is used.</remarks>
    /// <param name="path">Path of the file.</param>
    /// <param name="log">Receives a line when the file becomes invalid; null for no log.</param>
    /// <exception cref="InputException">
    /// A line is invalid, or the file has no token. The message names file and line, but does not contain the token.
    /// </exception>
    public static TokenList Read(string path, Action<string> log = null)
    {
        var tokens = new FollowedFile<(byte[] Hash, Role Role)[]>([path], (out string fault) =>
        {
            fault = null;
            return Hashed(Entries(path));
        }, Settles, log);
        if (tokens.Current.Length == 0)
            throw new InputException(TokenFileMessages.NoToken(path));
        return new TokenList(tokens, path) { _weak = [.. WeakEntries(path)] };
    }

    /// <summary>Gets the role of a token; null if the token is unknown. The duration is the same for all tokens.</summary>
    /// <param name="hash">Hash from <see cref="HashOf"/>.</param>
    public Role? RoleOf(byte[] hash)
    {
        var role = default(Role?);
        foreach (var known in _current())
        {
            // Compares every token completely, so that the duration does not reveal which token matches, or how many of its characters.
            if (CryptographicOperations.FixedTimeEquals(known.Hash, hash))
                role = known.Role;
        }

        return role;
    }

    /// <summary>Gets the hash of a token, SHA-256 of its UTF-8 bytes. Only this hash is stored and compared.</summary>
    public static byte[] HashOf(string token) => SHA256.HashData(Encoding.UTF8.GetBytes(token));

    /// <summary>Reads the file again if it has changed.</summary>
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
            throw new InputException(PathMessages.NotRead(path, e), e);
        }
    }

    static (string Token, Role Role) Entry(string line, string where)
    {
        var words = line.Split([' ', '\t'], StringSplitOptions.RemoveEmptyEntries);
        if (words.Length != 2 || !Roles.TryGetValue(words[0], out var role))
            throw new InputException(TokenFileMessages.NotALine(where));
        if (Encoding.UTF8.GetByteCount(words[1]) > ProtocolLimits.TokenBytes)
            throw new InputException(TokenFileMessages.TooLong(where, ProtocolLimits.TokenBytes));
        return (words[1], role);
    }
}
