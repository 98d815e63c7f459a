import type { AdapterContext } from '../adapter';
import { pause } from '../backoff';
import { READINGS_AT_ONCE } from '../clock/clockStep';
import { GatewayLink } from '../gateway/link';
import { TopicValues } from '../samples/topicValues';
import { RosFrames } from './frames';
import { JointNames } from './jointNames';
import { JointStates } from './jointStates';
import { renewing } from './subscriptionRenewals';
import { RobotDescription } from './robotDescription';
import { RobotTime } from './robotTime';
import { SetPoints } from './setPoints';
import { SimulationTime } from './simulationTime';
import type { RosSettings } from './kind';
import { TopicMessages } from './topicMessages';
import { beginningAt, beginsAtOnce, passedTrajectory } from './trajectory';
import { malformedMessages } from '../messages/broker';
import { rosMessages } from '../messages/ros';

const CLOCK_RETRY_MS = 1000;

/** Message types with their ROS 1 names. The rosbridge of ROS 2 also accepts these names. */
const JOINT_STATE = 'sensor_msgs/JointState';
const TRAJECTORY = 'trajectory_msgs/JointTrajectory';
const STRING = 'std_msgs/String';
const TRANSFORMS = 'tf2_msgs/TFMessage';

/** The field that contains the value in messages of std_msgs. */
const DATA = 'data';

/** Subscribes to topics of a robot's rosbridge and forwards its messages, until the adapter is stopped. */
export async function run(context: AdapterContext<RosSettings>): Promise<void> {
  const { configuration, gateway, clock, output, status, log, stopping } = context;
  const { settings } = configuration;
  const { oldest } = output.joints.options;
  const setPoints = new SetPoints(clock, gateway);
  const values = new TopicValues(configuration.values, DATA);
  const topics = new TopicMessages(values, output, clock);
  const simulation = new SimulationTime(clock, status);
  let connection = new AbortController();
  /** Whether the gateway's clock stamps the messages without a header, because the robot's clock is not available yet. */
  let isWithout = false;
  const doWithout = (): void => {
    if (!isWithout) void clock.doWithout(stopping).then(() => topics.check());
    isWithout = true;
    setPoints.check();
  };
  clock.stepped = () => topics.clockStepped();
  if (!settings.hasClock) doWithout();
  const robot = new GatewayLink({ url: settings.endpoint, token: null, pin: settings.pin }, log, 'rosbridge', {
    opened: () => {
      status.enter('connected');
      connection = new AbortController();
      const ended = AbortSignal.any([stopping, connection.signal]);
      const time = new RobotTime(robot);
      if (settings.hasClock) void attach(time, ended);
      void renewing(ended, connectedMs => {
        // The rosbridge of ROS 2 selects the durability of a subscription from the publishers that exist when it is created. A latched message of a
        // publisher that starts later would never arrive. Before version 2.2.0, the same applied to all messages of a best-effort publisher.
        if (!time.isRos1) robot.renewSilentSubscriptions();
        description?.check(connectedMs);
        frames.check(connectedMs, time.isRos1);
      });
    },
    away: reason => {
      connection.abort();
      clock.detach();
      setPoints.forget();
      topics.forget();
      simulation.forget();
      if (status.state === 'connected') status.reconnected();
      status.enter('waiting', reason);
    },
    malformed: (topic, problem) => status.refuse('malformed', topic, problem),
  });

  // Tries repeatedly, because rosapi may start later than rosbridge.
  async function attach(time: RobotTime, ended: AbortSignal): Promise<void> {
    while (!ended.aborted) {
      try {
        if (await clock.attach(() => time.read(), ended, READINGS_AT_ONCE)) {
          if (isWithout) topics.clockStepped();
          isWithout = false;
          setPoints.check();
          topics.check();
          return status.notice(null, 'clock');
        }
      } catch (error) {
        if (ended.aborted) return;
        doWithout();
        status.notice(rosMessages.noClock((error as Error).message), 'clock');
        await pause(CLOCK_RETRY_MS, ended);
      }
    }
  }

  const { namespace } = settings;
  const names = new JointNames(configuration.joints, namespace, settings.maxDeceleration);
  const states = new JointStates(names, oldest, clock, output.stamped, status, output.joints.silence);
  const passStates = (message: Record<string, unknown>): void => {
    simulation.check(settings.jointStates, message?.header);
    states.pass(message);
  };
  robot.subscribe(settings.jointStates, passStates, JOINT_STATE);
  const configured = namespace in configuration.robots ? configuration.robots[namespace] : configuration.robot;
  const description =
    configured !== null || settings.robotDescription === null ? null : new RobotDescription(settings.robotDescription, namespace, gateway, status);
  if (settings.jointTrajectory !== null) robot.subscribe(settings.jointTrajectory, passTrajectory, TRAJECTORY);

  const frames = new RosFrames(settings, oldest, clock, output.stamped, status, output.frames.states);
  if (configured !== null) frames.describe(configured);
  if (description !== null) robot.subscribe(description.topic, message => describe(description, message?.data), STRING);
  if (settings.frames.some(({ topic }) => topic === null)) robot.subscribe(settings.tf, passTransforms, TRANSFORMS);
  // An object with its own topic also needs the place of the robot, if ROS publishes one.
  if (settings.frames.length > 0) robot.subscribe(settings.tfStatic, message => frames.passStationary(message), TRANSFORMS);
  settings.frames.forEach(({ topic, type }, index) => {
    if (topic !== null) robot.subscribe(topic, message => frames.passPose(index, message), type);
  });
  output.signals.silence.unconfirmedMs = null;
  for (const topic of values.topics) robot.subscribe(topic, message => topics.pass(topic, message), settings.types.get(topic));

  function describe(of: RobotDescription, text: unknown): void {
    of.pass(text);
    if (typeof text === 'string') frames.describe(text);
  }

  function passTransforms(message: Record<string, unknown>): void {
    frames.pass(message, header => simulation.check(settings.tf, header));
  }

  function passTrajectory(message: Record<string, unknown>): void {
    const passed = passedTrajectory(message, names);
    if (passed === null) return status.refuse('malformed', 'trajectory', malformedMessages.forwardedTrajectory);
    status.accept('trajectory');
    if (!beginsAtOnce(passed)) setPoints.add(namespace, passed);
    else if (clock.now === null) status.count('clock-unknown');
    else setPoints.add(namespace, beginningAt(clock.now, passed));
  }

  status.detail('endpoint', settings.endpoint);
  status.detail('security', settings.endpoint.startsWith('wss:') ? 'tls' : 'none');
  if (settings.isPlain) log.line(rosMessages.notSecure);
  status.enter('connecting');
  await robot.run(stopping);
}
