using System.Buffers.Text;
using System.Security.Cryptography;
using Nowpose.Gateway.Security;

namespace Nowpose.Gateway.Operations;

/// <summary>
/// The sessions of browsers that have logged in with a token. A browser receives a random session id, because a page cannot store the token
/// safely. Thread-safe.
/// </summary>
/// <remarks>
/// Sessions are kept in memory only: after a restart of the gateway, users log in again. A session has the current rights of its token.
/// </remarks>
sealed class BrowserSessions(TimeProvider time)
{
    /// <summary>Maximum number of sessions. At the limit, a new session replaces the one that has been idle for the longest time.</summary>
    const int MaxCount = 256;

    const int IdBytes = 32;

    /// <summary>
    /// Idle time after which a session ends. An open page keeps its session, because it sends requests. A browser without an open page overnight
    /// needs a new login in the morning.
    /// </summary>
    static readonly TimeSpan MaxIdle = TimeSpan.FromHours(12);

    readonly Dictionary<string, Session> _sessions = [];

    /// <summary>Gets the name of the session cookie. It contains the port, because browsers share cookies between the ports of a host.</summary>
    public static string CookieOf(HttpContext context) => $"nowpose-{context.Connection.LocalPort}";

    /// <summary>Starts a session for a token.</summary>
    /// <param name="tokenHash">Hash of the token from <see cref="TokenList.HashOf"/>.</param>
    /// <returns>The session id for the browser: 32 random bytes as text.</returns>
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

    /// <summary>Gets the hash of a session's token, and restarts the session's idle time. Returns null for an unknown or expired session.</summary>
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

    /// <summary>Whether a session is valid. Does not restart its idle time.</summary>
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

    // Sessions are looked up by the hash of the id, so that the duration does not reveal how many characters of a guess are right.
    static string KeyOf(string id) => Convert.ToBase64String(TokenList.HashOf(id ?? ""));

    readonly record struct Session(byte[] TokenHash, long Used);
}
