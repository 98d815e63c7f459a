using System;
using Nowpose.Protocol;
using Nowpose.Sync;

namespace Nowpose.Network
{
    /// <summary>
    /// Adds the exchanges of one connection to the synchroniser, counts those that are dropped, and ends the connection after ten drops in a row.
    /// </summary>
    sealed class ExchangeIntake
    {
        readonly ClockSynchroniser _synchroniser;
        readonly SyncFaultCounters _faults;
        readonly Func<int, SyncExchangeFault, string> _refusal;
        int _dropsInARow;

        /// <param name="refusal">Text for a server whose replies are unusable: from the number of drops and the last fault.</param>
        public ExchangeIntake(ClockSynchroniser synchroniser, SyncFaultCounters faults, Func<int, SyncExchangeFault, string> refusal) =>
            (_synchroniser, _faults, _refusal) = (synchroniser, faults, refusal);

        /// <param name="fault">Fault found by the connection; a valid exchange may still be dropped by the synchroniser.</param>
        /// <returns>Whether the exchange was not dropped.</returns>
        /// <exception cref="GatewayRefusalException">Ten exchanges in a row were dropped.</exception>
        public bool Add(in SyncExchange exchange, SyncExchangeFault fault = SyncExchangeFault.None)
        {
            if (fault == SyncExchangeFault.None && _synchroniser.Add(exchange, out fault) == SyncVerdict.SetAside)
                _faults.Count(SyncExchangeFault.Contradiction);
            _faults.Count(fault);
            _dropsInARow = fault == SyncExchangeFault.None ? 0 : _dropsInARow + 1;
            if (_dropsInARow == ProtocolLimits.SyncDropsInARow) throw new GatewayRefusalException(_refusal(_dropsInARow, fault));
            return _dropsInARow == 0;
        }
    }
}
