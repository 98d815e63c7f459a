using Nowpose.Kinematics;
using Nowpose.Protocol;

namespace Nowpose.Session
{
    /// <summary>Result of comparing the displayed robot with the gateway's description.</summary>
    enum RobotDescriptionMatch
    {
        /// <summary>The gateway has not sent a valid description.</summary>
        Unknown,

        Same,

        /// <summary>The two URDFs differ: other lengths, axes or names may cause a wrong pose of the displayed robot.</summary>
        Different,
    }

    /// <summary>The newest valid robot description from the gateway, compared with the displayed robot. Thread-safe.</summary>
    sealed class ReceivedDescription
    {
        readonly RobotModel _displayed;
        // One object holds the text and the model, so that readers never see the text of one description with the model of another.
        volatile Parsed _newest = new Parsed(null, null, default);
        volatile string _fault;

        public ReceivedDescription(RobotModel displayed) => _displayed = displayed;

        /// <summary>URDF text of the newest valid description; null before the first.</summary>
        public string Text => _newest.Text;

        public RobotModel Model => _newest.Model;

        public RobotDescriptionMatch Match => _newest.Match;

        /// <summary>Single-line error message about the newest description; null if the description is valid.</summary>
        public string Fault => _fault;

        /// <summary>Reads a description. Skips the current description, which the gateway sends again after each reconnection.</summary>
        /// <returns>False if the description cannot be read; the previous description is kept.</returns>
        public bool Receive(string urdf)
        {
            string fault = null;
            try
            {
                if (urdf != Text) _newest = Read(urdf);
            }
            catch (InputException notUrdf)
            {
                fault = notUrdf.Message;
            }
            _fault = fault;
            return fault == null;
        }

        Parsed Read(string urdf)
        {
            var model = UrdfReader.Read(urdf, RosTopics.RobotDescription);
            var isSame = model.SourceHash == _displayed.SourceHash;
            return new Parsed(urdf, model, isSame ? RobotDescriptionMatch.Same : RobotDescriptionMatch.Different);
        }

        sealed class Parsed
        {
            public Parsed(string text, RobotModel model, RobotDescriptionMatch match) => (Text, Model, Match) = (text, model, match);

            public string Text { get; }
            public RobotModel Model { get; }
            public RobotDescriptionMatch Match { get; }
        }
    }
}
