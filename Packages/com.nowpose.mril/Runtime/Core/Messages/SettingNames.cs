namespace Nowpose.Messages
{
    /// <summary>Names of settings in error messages.</summary>
    static class SettingNames
    {
        public const string MarkersOfBase = "markers of a base";
        public const string ToolSpeed = "speed of the tool";
        public const string DeviceModel = "the model's name";
        public const string VisualisationSpread = "spread of the visualisation latency";
        public const string MaxRenderTime = "maximum measured render time";
        public const string BuildingTime = "build time per frame";
        public const string HeadMotionUncertainty = "uncertainty of the head motion latency";
        public const string MaxSweepLoad = "maximum load of the sweep, vertices";
        public const string SweepSteps = "steps of the sweep";
        public const string SettlingTime = "time for a load to settle";
        public const string LoadTime = "duration of a load";
        public const string CodeMarkerSize = "cell code: marker size";
        public const string CodeSyncPort = "cell code: sync port";
        public const string CodeWebSocketPort = "cell code: WebSocket port";
        public const string CodeMarkerOffset = "cell code: marker offset";
        public const string MaxRecordingSize = "maximum size of the recording";
        public const string UrdfVelocityShare = "times the URDF's velocity limit";
    }
}
