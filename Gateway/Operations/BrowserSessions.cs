using System.Buffers.Text;
using System.Security.Cryptography;
using Nowpose.Gateway.Security;

namespace Nowpose.Gateway.Operations;

/// <summary>Browsers that showed a token once, and show a random name for it since: a page cannot keep a token as safely. Any thread.</summary>
/// <remarks>In memory only: a gateway that is started again asks again. A session is worth what its token is worth at the moment.</remarks>
sealed class BrowserSessions(TimeProvider time)
{
    /// <summary>Of more than this the one that was idle longest ends: who may log in does not fill the memory.</summary>
    const int GreatestCount = 256;

    const int IdBytes = 32;

    /// <summary>A browser that was left open asks again the next morning.</summary>
    static readonly TimeSpan GreatestIdle = TimeSpan.FromHours(12);

    readonly Dictionary<string, Session> _sessions = [];

    /// <summary>Another port is another gateway, but to a browser the same place.</summary>
    public static string CookieOf(HttpContext context) => $"nowpose-{context.Connection.LocalPort}";

    /// <param name="tokenHash">As <see cref="TokenList.HashOf"/> makes it.</param>
    /// <returns>What the browser shows from now on: 32 random bytes, as text.</returns>
    public string Open(byte[] tokenHash)
    {
        var id = Base64Url.EncodeToString(RandomNumberGenerator.GetBytes(IdBytes));
        lock (_sessions)
        {
            if (_sessions.Count >= GreatestCount) _sessions.Remove(_sessions.MinBy(session => session.Value.Used).Key);
            _sessions.Add(KeyOf(id), new Session(tokenHash, time.GetTimestamp()));
        }

        return id;
    }

    /// <summary>The hash of the token that was shown for it; null for what is no session, or none any more.</summary>
    public byte[] TokenHashOf(string id)
    {
        var key = KeyOf(id);
        lock (_sessions)
        {
            if (!_sessions.TryGetValue(key, out var session)) return null;
            if (time.GetElapsedTime(session.Used) > GreatestIdle)
            {
                _sessions.Remove(key);
                return null;
            }

            _sessions[key] = session with { Used = time.GetTimestamp() };
            return session.TokenHash;
        }
    }

    /// <summary>Whether it still counts; asking does not make it last longer.</summary>
    public bool IsOpen(string id)
    {
        lock (_sessions)
            return _sessions.TryGetValue(KeyOf(id), out var session) && time.GetElapsedTime(session.Used) <= GreatestIdle;
    }

    public void Close(string id)
    {
        lock (_sessions)
            _sessions.Remove(KeyOf(id));
    }

    // Looked up by its hash: how much of a guess fits does not show in the time.
    static string KeyOf(string id) => Convert.ToBase64String(TokenList.HashOf(id ?? ""));

    readonly record struct Session(byte[] TokenHash, long Used);
}
