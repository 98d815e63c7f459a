using System.Security.Cryptography;
using System.Text;
using Nowpose.Protocol;

namespace Nowpose.Gateway.Security;

/// <summary>The tokens a gateway accepts, each with its role. Keeps their hashes only.</summary>
public sealed class TokenList
{
    public static readonly TokenList None = new([]);

    readonly (byte[] Hash, Role Role)[] _tokens;

    public TokenList(IEnumerable<(string Token, Role Role)> tokens) =>
        _tokens = [.. tokens.Select(entry => (HashOf(entry.Token), entry.Role))];

    public bool IsEmpty => _tokens.Length == 0;

    /// <summary>Reads lines "observer TOKEN" or "source TOKEN"; empty lines and lines that start with # are skipped.</summary>
    /// <exception cref="InputException">A line is something else, or there is none. Names file and line, never the token.</exception>
    public static TokenList Read(string path)
    {
        var tokens = Lines(path)
            .Select((line, index) => (Text: line.Trim(), Number: index + 1))
            .Where(line => line.Text.Length > 0 && line.Text[0] != '#')
            .Select(line => Entry(line.Text, $"{path}, line {line.Number}"))
            .ToList();
        if (tokens.Count == 0)
            throw new InputException($"{path}: holds no token; allowed are lines \"observer TOKEN\" and \"source TOKEN\"");
        return new TokenList(tokens);
    }

    /// <summary>The role of a token, or null when it is none of these. Takes as long whichever it is.</summary>
    public Role? RoleOf(string token)
    {
        var hash = HashOf(token ?? "");
        var role = default(Role?);
        foreach (var known in _tokens)
        {
            // Every token is compared, whole: neither which one nor how much of it fits shows in the time.
            if (CryptographicOperations.FixedTimeEquals(known.Hash, hash))
                role = known.Role;
        }

        return role;
    }

    static string[] Lines(string path)
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
        if (words.Length != 2 || words[0] is not ("observer" or "source"))
            throw new InputException($"{where}: allowed is \"observer TOKEN\" or \"source TOKEN\", the token without blanks");
        if (Encoding.UTF8.GetByteCount(words[1]) > ProtocolLimits.TokenBytes)
            throw new InputException($"{where}: the token is longer than {ProtocolLimits.TokenBytes} bytes");
        return (words[1], words[0] == "source" ? Role.Source : Role.Observer);
    }

    static byte[] HashOf(string token) => SHA256.HashData(Encoding.UTF8.GetBytes(token));
}
