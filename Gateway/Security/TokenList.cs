using System.Security.Cryptography;
using System.Text;
using Nowpose.Gateway.Options;

namespace Nowpose.Gateway.Security;

/// <summary>The tokens that a gateway accepts, with their roles. Stores only hashes of the tokens. Thread-safe.</summary>
public sealed class TokenList
{
    public static readonly TokenList None = new([]);

    static readonly Dictionary<string, Role> Roles =
        new() { ["observer"] = Role.Observer, ["source"] = Role.Source, ["operator"] = Role.Operator };

    // Minimum age of a change before the file is read again. An editor that truncates the file first has then written the new content.
    internal static readonly TimeSpan Settles = TimeSpan.FromMilliseconds(250);

    readonly Func<Content> _current;
    readonly Func<string> _fault = () => null;
    readonly Action<string> _log = _ => { };

    // The content whose weak tokens have been reported.
    volatile Content _reported;

    public TokenList(IEnumerable<(string Token, Role Role)> tokens)
    {
        _reported = new Content([.. tokens.Select(entry => (HashOf(entry.Token), entry.Role, false))], []);
        _current = () => _reported;
        IsEmpty = _reported.Entries.Length == 0;
    }

    TokenList(FollowedFile<Content> file, string path, Action<string> log)
    {
        _reported = file.Current;
        _current = () => file.Current;
        _fault = () => file.Fault;
        _log = log ?? _log;
        Path = path;
    }

    /// <summary>File and line of each token that is too easy to guess, with its strength in bits.</summary>
    internal IReadOnlyList<(string Where, double Bits)> Weak => _current().Weak;

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
    /// A line is invalid, a token has two roles, or the file has no token. The message names file and line, but does not contain the token.
    /// </exception>
    public static TokenList Read(string path, Action<string> log = null)
    {
        var tokens = new FollowedFile<Content>([path], (out string fault) =>
        {
            fault = null;
            var entries = Entries(LinesOf(path), path).ToArray();
            return new Content(
                [.. entries.Select(entry => (HashOf(entry.Token), entry.Role, IsWeak(entry.Bits)))],
                [.. entries.Where(entry => IsWeak(entry.Bits)).Select(entry => (entry.Where, entry.Bits))]);
        }, Settles, log);
        if (tokens.Current.Entries.Length == 0)
            throw new InputException(TokenFileMessages.NoToken(path));
        return new TokenList(tokens, path, log);
    }

    /// <summary>Gets the role of a token; null if the token is unknown. The duration is the same for all tokens.</summary>
    /// <param name="hash">Hash from <see cref="HashOf"/>.</param>
    public Role? RoleOf(byte[] hash)
    {
        var role = default(Role?);
        foreach (var known in _current().Entries)
        {
            // Compares every token completely, so that the duration does not reveal which token matches, or how many of its characters.
            if (CryptographicOperations.FixedTimeEquals(known.Hash, hash))
                role = known.Role;
        }

        return role;
    }

    /// <summary>Whether a token of the file is too easy to guess, so that even a part of its hash would reveal it.</summary>
    /// <param name="hash">Hash from <see cref="HashOf"/>.</param>
    internal bool IsWeak(byte[] hash) =>
        Array.Exists(_current().Entries, known => known.IsWeak && CryptographicOperations.FixedTimeEquals(known.Hash, hash));

    /// <summary>Gets the hash of a token, SHA-256 of its UTF-8 bytes. Only this hash is stored and compared.</summary>
    public static byte[] HashOf(string token) => SHA256.HashData(Encoding.UTF8.GetBytes(token));

    /// <summary>Reads the file again if it has changed, and logs its weak tokens. Those of the start are warnings of the gateway.</summary>
    internal void Follow()
    {
        var content = _current();
        if (content == _reported) return;
        _reported = content;
        foreach (var line in Precautions.OfTokens(content.Weak)) _log(line);
    }

    static bool IsWeak(double bits) => bits < TokenStrength.MinBits;

    static IEnumerable<(string Token, Role Role, string Where, double Bits)> Entries(string[] lines, string path)
    {
        var known = new Dictionary<string, (Role Role, int Line)>();
        for (var number = 1; number <= lines.Length; number++)
        {
            var text = lines[number - 1].Trim();
            if (text.Length == 0 || text[0] == '#') continue;
            var where = $"{path}, line {number}";
            var (token, role) = Entry(text, where);
            if (!known.TryAdd(token, (role, number)) && known[token].Role != role)
                throw new InputException(TokenFileMessages.TwoRoles(path, known[token].Line, number));
            yield return (token, role, where, TokenStrength.BitsOf(token));
        }
    }

    static string[] LinesOf(string path) => FileFault.Report(() => File.ReadAllLines(path), e => PathMessages.NotRead(path, e));

    static (string Token, Role Role) Entry(string line, string where)
    {
        var words = line.Split([' ', '\t'], StringSplitOptions.RemoveEmptyEntries);
        if (words.Length != 2 || !Roles.TryGetValue(words[0], out var role))
            throw new InputException(TokenFileMessages.NotALine(where));
        if (Encoding.UTF8.GetByteCount(words[1]) > ProtocolLimits.TokenBytes)
            throw new InputException(TokenFileMessages.TooLong(where, ProtocolLimits.TokenBytes));
        return (words[1], role);
    }

    // The tokens of a file, and its lines with weak tokens.
    sealed class Content((byte[] Hash, Role Role, bool IsWeak)[] entries, IReadOnlyList<(string Where, double Bits)> weak)
    {
        public (byte[] Hash, Role Role, bool IsWeak)[] Entries => entries;
        public IReadOnlyList<(string Where, double Bits)> Weak => weak;
    }
}
