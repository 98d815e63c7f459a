using System.Buffers.Text;
using System.Security.Cryptography;
using Nowpose.Gateway.Security;

namespace Nowpose.Gateway.Operations;

/// <summary>
/// Sessions of browsers that have presented a token. A browser gets a random id instead of the token, because a page cannot store a token
/// safely. Thread-safe.
/// </summary>
/// <remarks>Kept in memory only, so a restarted gateway requires a new login. A session has the current rights of its token.</remarks>
sealed class BrowserSessions(TimeProvider time)
{
    /// <summary>Maximum number of sessions. Beyond it, the one that was idle longest ends, so that logins cannot exhaust the memory.</summary>
    const int MaxCount = 256;

    const int IdBytes = 32;

    /// <summary>Maximum idle time: a browser that was left open requires a new login the next morning.</summary>
    static readonly TimeSpan MaxIdle = TimeSpan.FromHours(12);

    readonly Dictionary<string, Session> _sessions = [];

    /// <summary>Gets the cookie's name. It includes the port, because browsers share cookies between the ports of a host.</summary>
    public static string CookieOf(HttpContext context) => $"nowpose-{context.Connection.LocalPort}";

    /// <param name="tokenHash">Hash from <see cref="TokenList.HashOf"/>.</param>
    /// <returns>The session's id for the browser: 32 random bytes as text.</returns>
    public string Open(byte[] tokenHash)
    {
        var id = Base64Url.EncodeToString(RandomNumberGenerator.GetBytes(IdBytes));
        lock (_sessions)
        {
            if (_sessions.Count >= MaxCount) _sessions.Remove(_sessions.MinBy(session => session.Value.Used).Key);
            _sessions.Add(KeyOf(id), new Session(tokenHash, time.GetTimestamp()));
        }

        return id;
    }

    /// <summary>Gets the hash of a session's token; null for an unknown or expired session.</summary>
    public byte[] TokenHashOf(string id)
    {
        var key = KeyOf(id);
        lock (_sessions)
        {
            if (!_sessions.TryGetValue(key, out var session)) return null;
            if (time.GetElapsedTime(session.Used) > MaxIdle)
            {
                _sessions.Remove(key);
                return null;
            }

            _sessions[key] = session with { Used = time.GetTimestamp() };
            return session.TokenHash;
        }
    }

    /// <summary>Whether the session is valid. This does not extend it.</summary>
    public bool IsOpen(string id)
    {
        lock (_sessions)
            return _sessions.TryGetValue(KeyOf(id), out var session) && time.GetElapsedTime(session.Used) <= MaxIdle;
    }

    public void Close(string id)
    {
        lock (_sessions)
            _sessions.Remove(KeyOf(id));
    }

    // Looked up by its hash, so that the time does not reveal how much of a guess is right.
    static string KeyOf(string id) => Convert.ToBase64String(TokenList.HashOf(id ?? ""));

    readonly record struct Session(byte[] TokenHash, long Used);
}
