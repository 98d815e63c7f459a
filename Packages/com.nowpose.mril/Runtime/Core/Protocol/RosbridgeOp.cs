namespace Nowpose.Protocol
{
    /// <summary>The operations of rosbridge v2 that headset and gateway exchange.</summary>
    enum RosbridgeOp
    {
        /// <summary>One this protocol has no use for.</summary>
        Unknown,

        Subscribe,
        Unsubscribe,
        Advertise,
        Unadvertise,
        Publish,
        CallService,
        ServiceResponse,

        /// <summary>From a plant's adapter: it answers a service from now on.</summary>
        AdvertiseService,

        UnadvertiseService,
        Status,

        /// <summary>Which statuses a client wants to be told.</summary>
        SetLevel,
    }
}
