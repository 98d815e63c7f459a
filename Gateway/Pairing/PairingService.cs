using Nowpose.Gateway.Security;
using Nowpose.Pairing;

namespace Nowpose.Gateway.Pairing;

/// <summary>Exchanges the token of the shown code for a headset's own token.</summary>
sealed class PairingService(GatewayOptions options, ShownCode shown, AccessControl accessControl, ConnectionCounters counters, Action<string> log)
{
    readonly WrongTokens _wrong = new(options.Time);

    /// <summary>POST /pair.</summary>
    public async Task ServeAsync(HttpContext context)
    {
        // A headset sends no Origin. Another site's page that tries codes does.
        if (!await accessControl.AdmitOriginAsync(context)) return;
        if (await RefuseBlockedAsync(context)) return;
        // The address may have been blocked by other requests while the body was being received.
        if (await SmallJson.ReadAsync(context) is not { } request || await RefuseBlockedAsync(context)) return;
        if (!request.TryGetValue("token", out var token) || !request.TryGetValue("name", out var name))
            await AccessControl.AnswerAsync(context, StatusCodes.Status400BadRequest, "token and name are needed");
        else
            await ExchangeAsync(context, token, name);
    }

    Task<bool> RefuseBlockedAsync(HttpContext context) =>
        AccessControl.RefuseBlockedAsync(context, _wrong, $"more than {PairingLimits.WrongCodesPerMinute} wrong codes in a minute");

    Task ExchangeAsync(HttpContext context, string token, string name)
    {
        PairedHeadset headset = null;
        string own;
        try
        {
            own = shown.Take(token, () => options.Headsets.Add(name, out headset));
        }
        catch (InputException fault)
        {
            // The code stays valid: the failure was not the headset's.
            log("pairing: " + fault.Message);
            return AccessControl.AnswerAsync(context, StatusCodes.Status503ServiceUnavailable, "the headset's token cannot be stored");
        }

        if (own != null)
        {
            log($"pairing: headset '{headset.Name}' received a token");
            return SmallJson.AnswerAsync(context, new { token = own });
        }

        _wrong.Count(context.Connection.RemoteIpAddress);
        counters.Count(Closure.Token);
        log("pairing: refused a wrong code");
        return AccessControl.AnswerAsync(context, StatusCodes.Status401Unauthorized, "this is not the current code");
    }
}
