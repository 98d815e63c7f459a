namespace Nowpose.Protocol
{
    /// <summary>The operations of rosbridge v2 that headset and gateway exchange.</summary>
    enum RosbridgeOp
    {
        /// <summary>An operation that this protocol does not support.</summary>
        Unknown,

        Subscribe,
        Unsubscribe,
        Advertise,
        Unadvertise,
        Publish,
        CallService,
        ServiceResponse,

        /// <summary>Sent by a plant's adapter to offer a service.</summary>
        AdvertiseService,

        UnadvertiseService,
        Status,

        /// <summary>Sets the minimum level of the statuses that a client receives.</summary>
        SetLevel,
    }
}
