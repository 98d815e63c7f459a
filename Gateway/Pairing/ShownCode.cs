using System.Security.Cryptography;
using Nowpose.Gateway.Security;
using Nowpose.Pairing;
using Base64Url = System.Buffers.Text.Base64Url;

namespace Nowpose.Gateway.Pairing;

/// <summary>The current pairing code, which a headset can exchange once for its own token. Thread-safe.</summary>
/// <remarks>A new code replaces it when it has been used, when it expires, and on request.</remarks>
sealed class ShownCode(CertificatePin pin, TimeProvider time)
{
    readonly object _gate = new();
    TokenCode _code;
    long _made;
    bool _isUsed = true;

    /// <summary>Gets the code to show.</summary>
    /// <param name="left">Remaining time of its validity.</param>
    public TokenCode Current(out TimeSpan left)
    {
        lock (_gate)
        {
            if (!IsValid) Make();
            left = PairingLimits.CodeValidity - time.GetElapsedTime(_made);
            return _code;
        }
    }

    /// <summary>Invalidates the shown code.</summary>
    public void Discard()
    {
        lock (_gate)
            _isUsed = true;
    }

    /// <summary>Exchanges the token in the current code, once.</summary>
    /// <param name="token">The token that a headset sent.</param>
    /// <param name="give">Creates the headset's own token. If it throws, the code stays valid.</param>
    /// <returns>The headset's own token; null if <paramref name="token"/> is not in the current code.</returns>
    public string Take(string token, Func<string> give)
    {
        lock (_gate)
        {
            // Compares even without a code, so that the duration does not reveal whether a code exists.
            var isIt = CryptographicOperations.FixedTimeEquals(TokenList.HashOf(token ?? ""), TokenList.HashOf(_code?.Token ?? ""));
            if (!isIt || !IsValid) return null;
            var given = give();
            _isUsed = true;
            return given;
        }
    }

    bool IsValid => !_isUsed && time.GetElapsedTime(_made) < PairingLimits.CodeValidity;

    void Make()
    {
        _made = time.GetTimestamp();
        _isUsed = false;
        _code = new TokenCode(
            pin, Base64Url.EncodeToString(RandomNumberGenerator.GetBytes(TokenCode.TokenBytes)),
            time.GetUtcNow().UtcDateTime + PairingLimits.CodeValidity);
    }
}
