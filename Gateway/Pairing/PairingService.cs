using Nowpose.Gateway.Security;
using Nowpose.Pairing;

namespace Nowpose.Gateway.Pairing;

/// <summary>Gives a headset its own token in exchange for the one-time token in the shown pairing code.</summary>
sealed class PairingService(GatewayOptions options, ShownCode shown, AccessControl accessControl, ConnectionCounters counters, Action<string> log)
{
    readonly WrongTokens _wrong = new(options.Time);

    /// <summary>Handles POST /pair, whose body is {"token": …, "name": …}.</summary>
    public async Task ServeAsync(HttpContext context)
    {
        // Refuses pages of other sites that try codes: browsers send the Origin header, headsets do not.
        if (!await accessControl.AdmitOriginAsync(context)) return;
        if (await RefuseBlockedAsync(context)) return;
        // Checks again after the body is received, because other requests may have blocked the address in the meantime.
        if (await SmallJson.ReadAsync(context) is not { } request || await RefuseBlockedAsync(context)) return;
        if (!request.TryGetValue("token", out var token) || !request.TryGetValue("name", out var name))
            await AccessControl.AnswerAsync(context, StatusCodes.Status400BadRequest, PairingServiceMessages.Fields);
        else
            await ExchangeAsync(context, token, name);
    }

    Task<bool> RefuseBlockedAsync(HttpContext context) =>
        accessControl.RefuseBlockedAsync(context, _wrong, PairingServiceMessages.TooManyWrong(PairingLimits.WrongCodesPerMinute));

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
            // The code stays valid, so that the headset can try again.
            log(PairingServiceMessages.NotStoredLog(fault.Message));
            return AccessControl.AnswerAsync(context, StatusCodes.Status503ServiceUnavailable, PairingServiceMessages.NotStored);
        }

        if (own != null)
        {
            accessControl.Log(context, PairingServiceMessages.TokenGiven, Role.Observer, headset.Hash, PairingServiceMessages.To(headset.Name));
            return SmallJson.AnswerAsync(context, new { token = own });
        }

        _wrong.Count(context.Connection.RemoteIpAddress);
        counters.Count(Closure.Token);
        accessControl.Log(context, PairingServiceMessages.WrongCodeLog, null, null);
        return AccessControl.AnswerAsync(context, StatusCodes.Status401Unauthorized, PairingServiceMessages.WrongCode);
    }
}
