using System;
using Nowpose.Kinematics;
using Nowpose.Protocol;

namespace Nowpose.Session
{
    /// <summary>The robot as the gateway describes it, read and compared with the one displayed. Immutable.</summary>
    sealed class ReceivedDescription
    {
        /// <summary>Nothing has been described yet.</summary>
        public static readonly ReceivedDescription None = new ReceivedDescription();

        ReceivedDescription() { }

        public string Text { get; private set; }
        public RobotModel Model { get; private set; }
        public RobotDescriptionMatch Match { get; private set; }

        /// <returns>Why the text is of no use; <see cref="DropReason.None"/> when it is.</returns>
        public static DropReason TryRead(string text, RobotModel displayed, out ReceivedDescription described)
        {
            described = null;
            try
            {
                var model = UrdfReader.Read(text, RosTopics.RobotDescription);
                var isSame = model.SourceHash == displayed.SourceHash;
                described = new ReceivedDescription
                {
                    Text = text,
                    Model = model,
                    Match = isSame ? RobotDescriptionMatch.Same : RobotDescriptionMatch.Different,
                };
                return DropReason.None;
            }
            catch (InputException)
            {
                return DropReason.NotUrdf;
            }
        }
    }
}
